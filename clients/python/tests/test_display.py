"""What a notebook shows: tables, pictures and pages, safe from markup in models."""

import base64
import html.parser
import pickle
import unittest
from fractions import Fraction

from shapecalculus import _display, check, simulate, sweep, trace, view

from .support import MODEL, program

EVIL = "<script>alert(1)</script>"



class Tags(html.parser.HTMLParser):
    """The tags of a text, with their attributes, and what stands between them."""

    def __init__(self, text):
        super().__init__()
        self.tags = []
        self.words = []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attributes):
        self.tags.append((tag, dict(attributes)))

    def handle_data(self, data):
        self.words.append(data)


def names(text):
    return {tag for tag, _ in Tags(text).tags}


class Texts(unittest.TestCase):
    def test_everything_is_escaped(self):
        row = {EVIL: EVIL, "verdict": EVIL, "why": '"><img src=x onerror=alert(1)>'}
        shown = _display.table([row], list(row), EVIL)
        self.assertEqual(names(shown), {"table", "caption", "thead", "tbody", "tr", "th", "td"})
        self.assertEqual(Tags(shown).words.count(EVIL), 4)
        self.assertEqual(names(_display.messages([EVIL])), {"pre"})

    def test_a_picture_is_an_image(self):
        ((tag, attributes),) = Tags(_display.picture("<svg>%s</svg>" % EVIL, '"' + EVIL)).tags
        self.assertEqual((tag, attributes["alt"]), ("img", '"' + EVIL))
        kind, data = attributes["src"].split(",")
        self.assertEqual(kind, "data:image/svg+xml;base64")
        self.assertEqual(base64.b64decode(data).decode(), "<svg>%s</svg>" % EVIL)

    def test_a_page_is_in_a_frame_of_its_own(self):
        content = '<p title="%s">\'%s&amp;</p>' % (EVIL, EVIL)
        ((tag, attributes),) = Tags(_display.page(content)).tags
        self.assertEqual((tag, attributes["srcdoc"]), ("iframe", content))
        # With allow-same-origin, its scripts would be those of the notebook.
        self.assertEqual(set(attributes["sandbox"].split()), {"allow-scripts", "allow-downloads"})

    def test_values(self):
        self.assertEqual(_display.plain(Fraction(1, 3)), "1/3")
        self.assertEqual(_display.plain(Fraction(10**40 + 1, 3)), "≈ 3.33333E+39")
        self.assertEqual(_display.plain(Fraction(1, 10**400)), "≈ 1E-400")
        self.assertEqual(_display.plain(float("inf")), "∞")
        self.assertEqual(_display.plain(None), "")
        self.assertEqual(len(_display.plain("x" * 10**6)), _display.LONGEST)

    def test_values_of_any_length(self):
        for zeros in (17, 639, 4299, 4300, 10**5):
            long = 10**zeros
            for value, shown in [(Fraction(long), "≈ 1E+%d"), (Fraction(-1, long), "≈ -1E-%d")]:
                self.assertEqual(_display.plain(value), shown % zeros)
            self.assertEqual(_display.plain(long), str(long) if zeros < 300 else "≈ 1E+%d" % zeros)

    def test_bounds_once(self):
        bounds = [{"limit": "interrupted"}, {"limit": "states"}, {"limit": "interrupted"}]
        known = {"states": 1, "transitions": 2, "depth": 3, "complete": False, "stopped_by": bounds}
        said = "1 states, 2 transitions, depth 3; stopped by: interrupted, states"
        self.assertEqual(_display.explored({"explored": known}), said)

    def test_long_tables_are_cut(self):
        rows = [{"n": n, "empty": None} for n in range(100)]
        shown = _display.table(rows, ["n", "empty"], most=5)
        self.assertEqual(shown.count("<tr>"), 6)
        self.assertIn("5 of 100 rows", shown)
        self.assertNotIn("empty", shown)


@unittest.skipIf(program() is None, "no scc: name it in the environment variable SCC")
class Results(unittest.TestCase):
    def plain(self, result):
        class Printer:
            written = ""

            def text(self, text):
                self.written += text

        printer = Printer()
        result._repr_pretty_(printer, False)
        return printer.written

    def test_verdicts(self):
        checked = check(MODEL + "check fails : always x(p) < -1 // %s\n" % EVIL, scc=program())
        shown = checked._repr_html_()
        self.assertIn("✗ violated", shown)
        self.assertIn("always x(p) &lt; -1", shown)
        self.assertNotIn("<script", shown)
        self.assertRegex(self.plain(checked), r"^<checked: 1 holds, 1 violated; \d+ states, .*>$")

    def test_simulations_and_sweeps(self):
        observed = simulate(MODEL, runs=3, observe="x(p)", every=1, until=30, scc=program())
        self.assertIn("of 93 rows", observed._repr_html_())
        self.assertEqual(self.plain(observed), "<simulated: 3 runs of x(p), at 31 times>")
        swept = sweep(MODEL, {"speed": [1, 2]}, scc=program())
        self.assertEqual(swept._repr_html_().count("✓ holds"), 2)
        self.assertEqual(self.plain(swept), "<swept: 2 holds over speed>")

    def test_long_numbers(self):
        model = MODEL.replace("translate (7,0,0)", "translate (5 * far*far*far*far*far + 2, 0, 0)")
        model = "param far = 1\n" + model + "check when : E = ? [ time U bound(p, q) ]\n"
        for zeros in (1, 700, 859, 860, 2000):
            far = {"far": 10**zeros}
            results = [sweep(model, {"far": [1, 10**zeros]}, scc=program()), trace(model, define=far, scc=program()),
                       check(model, define=far, scc=program()),
                       simulate(model, define=far, runs=1, observe="x(q)", every=1, until=1, scc=program())]
            # The bodies are 1 from their centres, and the speed is 2.
            self.assertEqual(results[0].rows[-1]["low"], Fraction(5 * 10 ** (5 * zeros), 2))
            for result in results:
                self.assertTrue(repr(result) and self.plain(result))
                self.assertIn("≈" if zeros > 1 else "5000", result._repr_html_())
                self.assertEqual(pickle.loads(pickle.dumps(result.rows)), result.rows)
                try:
                    self.assertTrue(str(result.to_dataframe()) and str(result.to_dataframe(as_float=True)))
                except ImportError:
                    pass  # no pandas

    def test_runs_and_pages(self):
        traced = trace(MODEL, scc=program())
        self.assertIn("<caption", traced._repr_html_())
        self.assertEqual(self.plain(traced), "<traced: 4 steps to time 9/2, quiescent>")
        picture, page = view(MODEL, svg=0, scc=program()), view(MODEL, scc=program())
        self.assertEqual(names(picture._repr_html_()), {"img"})
        ((tag, attributes),) = Tags(page._repr_html_()).tags
        self.assertEqual((tag, attributes["srcdoc"]), ("iframe", page.content))
        self.assertRegex(self.plain(page), "^<viewed: a page of [0-9]+ bytes>$")
        self.assertIsNone(view(MODEL, data=True, scc=program())._repr_html_())

    def test_plots(self):
        try:
            import matplotlib  # noqa: F401
        except ImportError:
            self.skipTest("no matplotlib")
        observed = simulate(MODEL, runs=3, observe=["x(p)", "x(q)"], every=1, until=3, scc=program())
        axes = observed.plot()
        self.assertEqual([text.get_text() for text in axes.get_legend().get_texts()], ["x(p)", "x(q)"])
        self.assertEqual([list(line.get_ydata()) for line in axes.lines[:1]], [[0, 2, 4, 5.75]])
        swept = sweep(MODEL, {"speed": [1, 2]}, scc=program())
        self.assertEqual([text.get_text() for text in swept.plot().get_xticklabels()], ["1", "2"])


if __name__ == "__main__":
    unittest.main()
