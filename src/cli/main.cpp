#include "cli/command_line.hpp"

#include <malloc.h>

int main(int argument_count, char** arguments) {
#ifdef __GLIBC__
    // What is measured and written takes tens of megabytes for a moment, again and again. Given back to the
    // system each time, it costs a third of the measuring to get them anew.
    constexpr int bytes_kept = 256 << 20;
    mallopt(M_MMAP_THRESHOLD, bytes_kept);
    mallopt(M_TRIM_THRESHOLD, bytes_kept);
#endif
    return vesica::command_line(argument_count, arguments);
}
