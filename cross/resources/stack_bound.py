"""Worst-case stack of every public function."""

from call_graph import INDIRECT, read_kernel
from helper_stack import add_helpers
from processors import Failure
from public_functions import declared, readable_names

# Functions that call through a pointer, and whose stack comes on top.
CALLS_BACK = {
    "write_stream": "the sink's",
    "check_stream": "the source's",
    "Boundary::step": "the sink's",
    "boundary_solid": "its own sink's",
    "StreamCursor::begin": "the source's",
    "StreamCursor::next": "the source's",
    "StreamCursor::next_or_leaves": "the source's",
    "StreamCursor::skip": "the source's",
    "StreamBuilder::begin": "the sink's",
    "StreamBuilder::leaf": "the sink's",
    "StreamBuilder::leaves": "the sink's",
    "StreamBuilder::finish": "the sink's",
    "StreamCombination::begin": "the source's and the sink's",
    "StreamCombination::begin_complement": "the source's and the sink's",
    "StreamCombination::step": "the source's and the sink's",
    "CsgConversion::begin": "the sources'",
    "CsgConversion::step": "the sources'",
    "convert_expression": "the sources'",
    "combine": "the source's and the sink's of streams",
    "complement": "the source's and the sink's of streams",
    "leaf_at": "the source's of a stream",
    "measure": "the source's of a stream",
    "digest": "the source's of a stream",
    "same_leaves": "the source's of streams",
    "RunSlicing::step": "the sink's",
    "BitmapSlicing::step": "the sink's",
}

TARGET = 1024  # bytes, for each function


def check_calls_back(graph, name, symbol):
    if graph.reaches(symbol, INDIRECT) and name not in CALLS_BACK:
        raise Failure(f"{name} calls through a pointer that is not accounted for")


def check_whole_graph(graph):
    """Recursion and unknown frames are errors wherever they are, also below no public function."""
    for name in sorted(graph.frames):
        graph.deepest(name)


def of_memory_source(graph):
    """What comes on top while the kernel's own source in memory is read."""
    readers = [symbol for symbol in graph.frames if "read_memory" in symbol]
    if len(readers) != 1:
        raise Failure(f"expected one source in memory, found {len(readers)}")
    return graph.deepest(readers[0])


def bounds(build, whole_image):
    """Bytes by the public functions' names, without the namespace; and how many more painting may show, as it reads
    streams from memory."""
    graph = read_kernel(build)
    add_helpers(graph, whole_image)
    check_whole_graph(graph)
    public = declared(build.kernel)
    found = {}
    for symbol, name in readable_names(graph.frames.keys() | graph.aliases.keys()).items():
        if name not in public or ":" in symbol:
            continue
        check_calls_back(graph, name, symbol)
        found[name] = max(graph.deepest(symbol), found.get(name, 0))
    missing = sorted(public - found.keys())
    if missing:
        raise Failure(f"declared but nowhere defined: {', '.join(missing)}")
    source = of_memory_source(graph)
    return found, {name: source for name, whose in CALLS_BACK.items() if "source" in whose}
