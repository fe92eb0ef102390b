// What can be asked of a tree, each answer against the grid's cells.
#ifndef OSEM_FUZZ_QUESTIONS_HPP
#define OSEM_FUZZ_QUESTIONS_HPP

#include "support/choices.hpp"
#include "support/forest.hpp"

namespace osem::fuzz {

void ask_point(const Forest::Entry& entry, Choices& choices);
void ask_box(const Forest::Entry& entry, Choices& choices);
void ask_segment(const Forest::Entry& entry, Choices& choices);
void ask_neighbour(const Forest::Entry& entry, Choices& choices);
void ask_nearest(const Forest::Entry& entry, Choices& choices);
void ask_collision(const Forest::Entry& a, const Forest::Entry& b, Choices& choices);
void ask_slice(const Forest::Entry& entry, Choices& choices);

/// Leaves, nodes, volumes, walks.
void ask_measures(const Forest::Entry& entry);
void ask_moments(const Forest::Entry& entry);
void ask_surface(const Forest::Entry& entry, Choices& choices);
void ask_components(const Forest::Entry& entry, Choices& choices);

} // namespace osem::fuzz

#endif
