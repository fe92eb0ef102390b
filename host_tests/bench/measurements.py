"""The measurements of one run of osem_bench, by theme, solid, cells along an axis and method."""

TO_MS = {"ns": 1e-6, "us": 1e-3, "ms": 1, "s": 1e3}
NO_COUNTERS = {"name", "run_name", "run_type", "repetitions", "repetition_index", "threads", "iterations", "real_time",
               "cpu_time", "time_unit", "family_index", "per_family_instance_index", "aggregate_name",
               "aggregate_unit"}


class Measurement:
    def __init__(self, ms, counters):
        self.ms = ms
        self.counters = counters


class Measurements:
    def __init__(self, results):
        self._context = results["context"]
        self._found = {}
        for one in results["benchmarks"]:
            if one.get("run_type") == "iteration" and not one.get("error_occurred"):
                self._add(one)

    def _add(self, one):
        theme, solid, cells, method, *how = one["run_name"].split("/")
        key = (theme, solid, int(cells), method)
        ms = one["real_time" if "manual_time" in how else "cpu_time"] * TO_MS[one["time_unit"]]
        if key not in self._found or ms < self._found[key].ms:
            counters = {name: value for name, value in one.items() if name not in NO_COUNTERS}
            self._found[key] = Measurement(ms, counters)

    def get(self, theme, solid, cells, method):
        return self._found.get((theme, solid, cells, method))

    def ms(self, theme, solid, cells, method):
        one = self.get(theme, solid, cells, method)
        return None if one is None else one.ms

    def subjects(self, theme):
        """Solids and grids of a theme, in the order in which they were measured."""
        return list(dict.fromkeys((key[1], key[2]) for key in self._found if key[0] == theme))

    def has_method(self, theme, method):
        return any(key[0] == theme and key[3] == method for key in self._found)

    def context(self):
        load = ", ".join(f"{value:.1f}" for value in self._context.get("load_avg", []))
        return (f"{self._context['num_cpus']} processors at {self._context['mhz_per_cpu']} MHz, load {load}, "
                f"{self._context['date'][:10]}")

    def as_list(self):
        """As dictionaries; `side` is in cells, whereas the counter `cells` says how many are inside."""
        return [{"theme": key[0], "solid": key[1], "side": key[2], "method": key[3], "ms": one.ms, **one.counters}
                for key, one in self._found.items()]
