// tlsph: one command a study. Errors become exit codes here and nowhere else.
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <new>

#include "commands.hpp"
#include "tlsph/core/error.hpp"

namespace {

using tlsph::ExitCode;

ExitCode complain(const std::string& message, ExitCode code) {
  fmt::print(stderr, "{}\n", message);
  return code;
}

ExitCode run_program(int argc, const char* const* argv) {
  try {
    const auto line = tlsph::parse_command_line(argc, argv);
    return line ? tlsph::execute(*line) : ExitCode::done;
  } catch (const tlsph::InputError& error) {
    return complain(error.what(), ExitCode::bad_input);
  } catch (const tlsph::NumericalError& error) {
    return complain(error.what(), ExitCode::numerical_failure);
  } catch (const tlsph::OutputError& error) {
    return complain(error.what(), ExitCode::no_output);
  } catch (const std::filesystem::filesystem_error& error) {
    return complain(error.what(), ExitCode::no_output);
  } catch (const std::bad_alloc&) {
    return complain("out of memory; choose a larger body.spacing", ExitCode::bad_input);
  } catch (const std::exception& error) {
    return complain(fmt::format("internal error: {}", error.what()), ExitCode::internal_error);
  }
}

}  // namespace

int main(int argc, char** argv) {
  return static_cast<int>(run_program(argc, argv));
}
