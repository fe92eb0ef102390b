// How long something takes.
#ifndef OSEM_HOST_STOPWATCH_HPP
#define OSEM_HOST_STOPWATCH_HPP

#include <chrono>

namespace osem::host {

class Stopwatch {
  public:
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

} // namespace osem::host

#endif
