// Measures the stack of every public function on inputs that take it down its deeper paths. Prints
// `stack NAME BYTES` for each; measure.py compares with the bounds. The exit code is 1 when a call does not
// give what it should.
#include "paint/paint.hpp"

namespace osem::cross {

namespace {

StaticNodePool<40000> trees_pool;
StaticNodePool<20000> results_pool;
bool good = true;

} // namespace

NodePool& pool = trees_pool;
NodePool& other_pool = results_pool;

void expect(bool condition) { good = good && condition; }

void print_stack(const char* name, std::uint32_t bytes) {
    expect(bytes != no_paint_left);
    port::print("stack osem::");
    port::print(name);
    port::print(" ");
    port::print_number(bytes);
    port::print("\n");
}

namespace {

bool paint_all() {
    const PaintTrees trees = paint_solids();
    paint_bintree();
    paint_booleans(trees);
    paint_queries(trees);
    paint_measures(trees);
    paint_trees(trees);
    paint_transforms(trees);
    paint_slices(trees);
    paint_boundary(trees);
    paint_streams(trees);
    paint_csg(trees);
    paint_fit(trees);
    paint_memory(trees);
    return good;
}

} // namespace

} // namespace osem::cross

int main(int, char**) {
    if (osem::cross::paint_all()) return 0;
    osem::port::print("stack: a call gave a wrong result\n");
    return 1;
}
