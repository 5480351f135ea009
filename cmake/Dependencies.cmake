# Every third party, found once. Debian 12 packages; nothing is downloaded.
include(LinkDependencies)
pkg_check_modules(armadillo REQUIRED IMPORTED_TARGET armadillo)  # of the studies
find_package(nanoflann REQUIRED)
find_package(Boost REQUIRED)  # Boost.Polygon, headers only
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
