"""What Osem's speed is meant to be, and whether it is."""

PAIR = "armadillo+elephant"


def ratio(a, b):
    return None if a is None or b is None else a / b


def quotient(found, key, counter, scale=1.0):
    """Scaled milliseconds a unit of a counter."""
    one = found.get(*key)
    return None if one is None or not one.counters.get(counter) else one.ms * scale / one.counters[counter]


def bytes_a_node(found):
    one = found.get("convert", "armadillo", 1024, "osem-three")
    return None if one is None else ratio(one.counters.get("result_bytes"), one.counters.get("nodes"))


def ns_a_small_face(found):
    """From one sphere to one of four times the triangles, all smaller than a leaf, only these are new."""
    few = found.get("convert", "dot-327680", 1024, "osem-three")
    many = found.get("convert", "dot-1310720", 1024, "osem-three")
    if few is None or many is None:
        return None
    return (many.ms - few.ms) * 1e6 / (many.counters["triangles"] - few.counters["triangles"])


def conversion_targets(found):
    def convert(solid, cells, method):
        return found.ms("convert", solid, cells, method)

    for solid in ("armadillo", "rotor", "bracket"):
        for cells in (512, 1024):
            runs = convert(solid, cells, "scan-runs")
            yield (f"centre, {solid} at {cells}: time, to the runs scanline's", "<=", 1.0, "x",
                   ratio(convert(solid, cells, "osem-centre"), runs))
            yield (f"three-valued, {solid} at {cells}: time, to the runs scanline's", "<=", 2.5, "x",
                   ratio(convert(solid, cells, "osem-three"), runs))
            simple = convert(solid, cells, "scan-simple")
            yield (f"centre, {solid} at {cells}: time, to the simple scanline's", "<=", 1.0, "x",
                   ratio(convert(solid, cells, "osem-centre"), simple))
            yield (f"three-valued, {solid} at {cells}: time, to the simple scanline's", "<=", 2.5, "x",
                   ratio(convert(solid, cells, "osem-three"), simple))
        yield (f"OpenVDB, {solid} at 1024: time, to ours with centre leaves", ">=", 50, "x",
               ratio(convert(solid, 1024, "vdb-fill"), convert(solid, 1024, "osem-centre")))
    yield "a face smaller than a leaf, at 1024", "<=", 100, "ns", ns_a_small_face(found)
    yield ("a boundary leaf, rotor at 1024", "<=", 12, "ns",
           quotient(found, ("convert", "rotor", 1024, "osem-three"), "boundary_cells", 1e6))
    yield ("two threads, armadillo at 1024: time of one, to theirs", ">=", 1.7, "x",
           ratio(found.ms("threads", "armadillo", 1024, "threads-1"),
                 found.ms("threads", "armadillo", 1024, "threads-2")))
    yield "pool, bytes an internal node", "<=", 6, "bytes", bytes_a_node(found)


def boolean_targets(found):
    def union(method):
        return found.ms("union", PAIR, 1024, method)

    yield ("MaskGrid topology union at 1024: time, to the pool's", ">=", 5, "x",
           ratio(union("vdb-topology"), union("osem-pool")))
    yield ("CGAL corefinement at 1024: time, to the pool's", ">=", 100, "x", ratio(union("cgal"), union("osem-pool")))
    for text, method in (("checked on the way", "osem-stream"), ("checked before", "osem-stream-checked"),
                         ("with indexes", "osem-stream-indexed")):
        for cells in (1024, 2048):
            yield (f"union of streams {text}, at {cells}, an input node", "<=", 1, "ns",
                   quotient(found, ("union", PAIR, cells, method), "nodes", 1e6))


def judged(found):
    """Rows: target, limit, measured, met or missed; one for each that a part of the measurements says something of."""
    rows = []
    for text, sense, limit, unit, value in [*conversion_targets(found), *boolean_targets(found)]:
        if value is None:
            continue
        met = value <= limit if sense == "<=" else value >= limit
        rows.append([text, f"{sense} {limit} {unit}", f"{value:.3g} {unit}", "met" if met else "missed"])
    return rows
