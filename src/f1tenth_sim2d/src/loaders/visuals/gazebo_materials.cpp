#include "loaders/visuals/gazebo_materials.h"

#include <map>

namespace f1tenth_sim2d
{
std::optional<GazeboMaterial> gazeboMaterial(const std::string & name)
{
  static const std::map<std::string, GazeboMaterial> kMaterials{
    {"Black", {{0.02F, 0.02F, 0.02F}}},
    {"Blue", {{0.0F, 0.0F, 1.0F}}},
    {"BlueGlow", {{0.0F, 0.0F, 1.0F}, Pattern::kNone, true}},
    {"BlueTransparent", {{0.0F, 0.0F, 1.0F}}},
    {"Bricks", {{0.62F, 0.33F, 0.25F}, Pattern::kBricks}},
    {"CeilingTiled", {{0.88F, 0.87F, 0.83F}, Pattern::kTiles}},
    {"DarkGrey", {{0.175F, 0.175F, 0.175F}}},
    {"DarkOrangeTransparent", {{1.0F, 0.4F, 0.04F}}},
    {"DarkYellow", {{0.7F, 0.7F, 0.0F}}},
    {"FlatBlack", {{0.1F, 0.1F, 0.1F}}},
    {"Gold", {{0.8F, 0.65F, 0.12F}}},
    {"Grass", {{0.30F, 0.47F, 0.20F}, Pattern::kSpeckles}},
    {"Green", {{0.0F, 1.0F, 0.0F}}},
    {"GreenGlow", {{0.0F, 1.0F, 0.0F}, Pattern::kNone, true}},
    {"GreenTransparent", {{0.0F, 1.0F, 0.0F}}},
    {"Grey", {{0.7F, 0.7F, 0.7F}}},
    {"GreyTransparent", {{0.5F, 0.5F, 0.5F}}},
    {"Indigo", {{0.33F, 0.0F, 0.5F}}},
    {"LightWood", {{0.80F, 0.62F, 0.42F}, Pattern::kPlanks}},
    {"Orange", {{1.0F, 0.51F, 0.05F}}},
    {"OrangeTransparent", {{1.0F, 0.44F, 0.0F}}},
    {"PaintedWall", {{0.80F, 0.78F, 0.72F}, Pattern::kSpeckles}},
    {"Purple", {{1.0F, 0.0F, 1.0F}}},
    {"PurpleGlow", {{1.0F, 0.0F, 1.0F}, Pattern::kNone, true}},
    {"Red", {{1.0F, 0.0F, 0.0F}}},
    {"RedBright", {{0.87F, 0.26F, 0.07F}}},
    {"RedGlow", {{1.0F, 0.0F, 0.0F}, Pattern::kNone, true}},
    {"RedTransparent", {{1.0F, 0.0F, 0.0F}}},
    {"Residential", {{0.60F, 0.55F, 0.50F}, Pattern::kBricks}},
    {"Road", {{0.33F, 0.33F, 0.34F}, Pattern::kSpeckles}},
    {"Runway", {{0.40F, 0.40F, 0.40F}, Pattern::kSpeckles}},
    {"SkyBlue", {{0.13F, 0.44F, 0.70F}}},
    {"Turquoise", {{0.0F, 1.0F, 1.0F}}},
    {"TurquoiseGlow", {{0.0F, 1.0F, 1.0F}, Pattern::kNone, true}},
    {"White", {{1.0F, 1.0F, 1.0F}}},
    {"WhiteGlow", {{1.0F, 1.0F, 1.0F}, Pattern::kNone, true}},
    {"Wood", {{0.62F, 0.42F, 0.25F}, Pattern::kPlanks}},
    {"WoodFloor", {{0.66F, 0.48F, 0.31F}, Pattern::kPlanks}},
    {"WoodPallet", {{0.70F, 0.55F, 0.36F}, Pattern::kPlanks}},
    {"Yellow", {{1.0F, 1.0F, 0.0F}}},
    {"YellowGlow", {{1.0F, 1.0F, 0.0F}, Pattern::kNone, true}},
    {"YellowTransparent", {{1.0F, 1.0F, 0.0F}}},
    {"ZincYellow", {{0.97F, 0.95F, 0.21F}}},
  };
  const auto found = kMaterials.find(name);
  return found == kMaterials.end() ? std::nullopt : std::make_optional(found->second);
}
}  // namespace f1tenth_sim2d
