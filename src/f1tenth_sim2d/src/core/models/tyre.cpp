#include "core/models/tyre.h"

#include <workspace_support/maths/trigonometry.h>
#include <cmath>

namespace f1tenth_sim2d
{
namespace maths = workspace_support::maths;

namespace
{
double arcTangent(double x)
{
  return maths::atan2(x, 1.0);
}

double cosineOfArcTangent(double x)
{
  return 1.0 / std::sqrt(1.0 + x * x);
}

/// The argument of the magic formula: its stiffness factor times slip, bent by the curvature factor.
double bent(double stiffness_times_slip, double curvature)
{
  return stiffness_times_slip - curvature * (stiffness_times_slip - arcTangent(stiffness_times_slip));
}

struct MagicFormula
{
  double stiffness;
  double shape;
  double curvature;
  double peak;        ///< N
  double shift{0.0};  ///< rad, of the argument of the sine

  TyreForce operator()(double slip) const
  {
    const double x = stiffness * slip;
    const double argument = bent(x, curvature);
    const maths::SineCosine form = maths::sineCosine(shape * arcTangent(argument) + shift);
    const double bend = stiffness * (1.0 - curvature * (1.0 - 1.0 / (1.0 + x * x)));
    return {peak * form.sine, peak * form.cosine * shape * bend / (1.0 + argument * argument)};
  }
};

TyreForce operator*(double share, const TyreForce & force)
{
  return {share * force.value, share * force.slope};
}

/// The cosine form, by which one kind of slip weakens the force of the other; 1 where slip is -shift.
double weakening(double stiffness, double shape, double curvature, double slip, double shift)
{
  const auto form = [&](double x) {
    return maths::sineCosine(shape * arcTangent(bent(stiffness * x, curvature))).cosine;
  };
  return form(slip + shift) / form(shift);
}
}  // namespace

Tyre::Tyre(const VehicleParameters & p)
: tire_(p.tire), friction_along_(p.tire.p_dx1 * p.mu / p.tire.p_dy1), friction_aside_(p.mu)
{
}

TyreForces Tyre::forces(double slip, double angle, double load) const
{
  TyreForces forces;
  forces.along = alongShare(slip, angle) * alongPure(slip, load);
  forces.aside = asideShare(slip, angle) * asidePure(angle, load);
  forces.aside.value += asideBySlip(slip, angle, load);
  return forces;
}

// The vertical shift is within the sine, as in CommonRoad's code.
TyreForce Tyre::alongPure(double slip, double load) const
{
  const double stiffness = tire_.p_kx1 / (tire_.p_cx1 * friction_along_);
  const MagicFormula formula{stiffness, tire_.p_cx1, tire_.p_ex1, friction_along_ * load, load * tire_.p_vx1};
  return formula(slip + tire_.p_hx1);
}

TyreForce Tyre::asidePure(double angle, double load) const
{
  const double stiffness = tire_.p_ky1 / (tire_.p_cy1 * friction_aside_);
  return MagicFormula{stiffness, tire_.p_cy1, tire_.p_ey1, friction_aside_ * load}(angle);
}

double Tyre::alongShare(double slip, double angle) const
{
  const double stiffness = tire_.r_bx1 * cosineOfArcTangent(tire_.r_bx2 * slip);
  return weakening(stiffness, tire_.r_cx1, tire_.r_ex1, angle, tire_.r_hx1);
}

// CommonRoad counts longitudinal slip the other way round: positive when braked.
double Tyre::asideShare(double slip, double angle) const
{
  const double stiffness = tire_.r_by1 * cosineOfArcTangent(tire_.r_by2 * (angle - tire_.r_by3));
  return weakening(stiffness, tire_.r_cy1, tire_.r_ey1, -slip, tire_.r_hy1);
}

double Tyre::asideBySlip(double slip, double angle, double load) const
{
  const double peak = friction_aside_ * load * tire_.r_vy1 * cosineOfArcTangent(tire_.r_vy4 * angle);
  return peak * maths::sineCosine(tire_.r_vy5 * arcTangent(-tire_.r_vy6 * slip)).sine;
}
}  // namespace f1tenth_sim2d
