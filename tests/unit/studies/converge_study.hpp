#pragma once
/// \file
/// Convergence studies of a scene in a folder for one test.

#include <string>
#include <utility>
#include <vector>

#include "study_folder.hpp"
#include "tlsph/studies/converge.hpp"

namespace tlsph {

class Converge : public StudyFolder {
 protected:
  ConvergenceRequest request(const std::string& scene, std::vector<double> spacings,
                             std::vector<std::string> overrides = {}) const {
    ConvergenceRequest request;
    request.scene = write("scene.toml", scene);
    request.overrides = std::move(overrides);
    request.spacings = std::move(spacings);
    return request;
  }
  ConvergenceTable study(const std::string& scene, std::vector<double> spacings,
                         std::vector<std::string> formulations = {},
                         std::vector<std::string> overrides = {}) {
    ConvergenceOptions options;
    options.out = folder / "out";
    options.threads = 1;
    ConvergenceRequest asked = request(scene, std::move(spacings), std::move(overrides));
    asked.formulations = std::move(formulations);
    return converge(asked, options);
  }
};

}  // namespace tlsph
