#pragma once
/// \file
/// Other programs on the same scene: scripts validation/peers/<name>.py, called with the scene's
/// name, a spacing, an end time and, for those that can choose, a share of the critical step and a
/// law, answering with one line of JSON (validation/peers/README.md).

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include "tlsph/studies/chart.hpp"

namespace tlsph {

/// InputError, naming `--peer` and those there are, for a name that is none; and for overrides that
/// make the scene another than the peers know.
void check_peers(const std::vector<std::string>& names, const std::vector<std::string>& overrides);

/// A peer as it is to run.
struct PeerVariant {
  std::string script;  ///< its name
  std::string label;   ///< the same and what is not the scene's
  double share = 0.9;  ///< of the critical step
  std::string law;     ///< empty: the scene's
};

struct PeerRun {
  ChartPoint point;
  std::string unable;  ///< why there is no point
};

/// One run of a peer, killed after `seconds`; its words go into files in `folder`.
[[nodiscard]] PeerRun run_peer(const PeerVariant& variant, const Scene& scene, double spacing,
                               const ChartTable& table, const std::filesystem::path& folder,
                               double seconds, const std::atomic<bool>* stop_requested);

}  // namespace tlsph
