// All the memory of the replay: one static block, carved from both ends.
#ifndef OSEM_CROSS_REPLAY_ARENA_HPP
#define OSEM_CROSS_REPLAY_ARENA_HPP

#include <cstddef>
#include <cstdint>
#include <new>

namespace osem::cross {

/// What outlives a step of the work is taken from the back (nodes), the rest from the front.
class Arena {
  public:
    Arena(std::uint8_t* memory, std::size_t size) : memory_(memory), back_(size) {}

    /// Room for `count` objects; null when there is too little.
    template <class T>
    T* take(std::size_t count) {
        const std::size_t start = (front_ + alignof(T) - 1) / alignof(T) * alignof(T);
        if (start > back_ || count > (back_ - start) / sizeof(T)) return nullptr;
        front_ = start + count * sizeof(T);
        return made<T>(start, count);
    }

    template <class T>
    T* take_back(std::size_t count) {
        if (count > (back_ - front_) / sizeof(T)) return nullptr;
        const std::size_t start = (back_ - count * sizeof(T)) / alignof(T) * alignof(T);
        if (start < front_) return nullptr;
        back_ = start;
        return made<T>(start, count);
    }

  private:
    friend class ArenaScope;

    template <class T>
    T* made(std::size_t start, std::size_t count) {
        T* first = reinterpret_cast<T*>(memory_ + start);
        for (std::size_t i = 0; i < count; ++i) ::new (static_cast<void*>(first + i)) T;
        return first;
    }

    std::uint8_t* memory_;
    std::size_t front_ = 0;
    std::size_t back_;
};

/// Gives back at its end whatever was taken since its start.
class ArenaScope {
  public:
    explicit ArenaScope(Arena& arena) : arena_(arena), front_(arena.front_), back_(arena.back_) {}
    ~ArenaScope() {
        arena_.front_ = front_;
        arena_.back_ = back_;
    }
    ArenaScope(const ArenaScope&) = delete;
    ArenaScope& operator=(const ArenaScope&) = delete;

  private:
    Arena& arena_;
    std::size_t front_;
    std::size_t back_;
};

} // namespace osem::cross

#endif
