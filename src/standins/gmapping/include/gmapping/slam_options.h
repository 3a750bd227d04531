#pragma once

#include <optional>

namespace gmapping
{
/// Of a map: a larger one does not fit into memory.
constexpr double kMostCells = 4e8;

/// How odometry errs: standard deviations that grow with the way driven. As errors of slip add up, the mapper assumes
/// larger ones: 2 to 40 times for matching, 4 times in the pose graph.
struct MotionNoise
{
  double srr{0.1};  ///< m per m: of translation, by translation; along the way, and less across it
  double srt{0.2};  ///< rad per m: of rotation, by translation
  double str{0.1};  ///< m per rad: of translation, by rotation; across the way
  double stt{0.2};  ///< rad per rad: of rotation, by rotation
};

/// How a scan is matched to a map.
struct MatcherOptions
{
  double sigma{0.05};         ///< m, standard deviation of a beam's end across a wall, for the search
  int kernel_size{1};         ///< cells around a beam's end in which a wall is looked for
  int iterations{5};          ///< greatest number of steps of the search, for each of its two widths
  int lskip{0};               ///< beams left out after each one that counts
  double minimum_score{0.0};  ///< beams that must fit for the scan to count more than odometry alone
};

/// Options of GridSlam. Names and defaults are those of gmapping.
struct SlamOptions
{
  MotionNoise motion;
  MatcherOptions matcher;
  std::optional<double> max_range;   ///< m, a beam this long hit nothing; default: that of the first scan
  std::optional<double> max_urange;  ///< m, farther than this nothing is put into the map; default: max_range
  double linear_update{1.0};         ///< m between scans that count
  double angular_update{0.5};        ///< rad between scans that count
  double temporal_update{-1.0};      ///< s between scans that count while standing; negative: none
  double xmin{-100.0};               ///< m, least extent of the map
  double ymin{-100.0};               ///< m
  double xmax{100.0};                ///< m
  double ymax{100.0};                ///< m
  double delta{0.05};                ///< m, size of a cell; at least 0.001
  double occ_thresh{0.25};           ///< share of beams that end in a cell above which it is occupied

  /// @throws OptionError that names the parameter
  void validate() const;
};
}  // namespace gmapping
