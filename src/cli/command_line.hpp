#pragma once

namespace vesica {

/// The program `vesica`: reads the command line, does what it says, returns the exit status. 0 done; 1 the
/// run failed; 2 the input is wrong; 3 stopped on request with a checkpoint written. Errors go to stderr.
int command_line(int argument_count, const char* const* arguments);

} // namespace vesica
