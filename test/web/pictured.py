"""Ten scenes, light and dark, against pictures of them that a person has looked at: pictures/NAME-THEME.png.

By hand: PICTURES=FOLDER saves the pictures anew, to be looked at and kept.
"""
import os

from browser_test import check
from scenes import address, blank, saved

PICTURES = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'pictures')

#: Names, models, and scripts that lead to a state and a camera.
SCENES = [
    ('why', 'hexokinase', ''),
    ('compared', 'hexokinase', 'scc.compare(scc.runs().findIndex((run) => run.name === "surely, otherwise"))'),
    ('open', 'hexokinase', 'scc.open(0); scc.go(0); press("names")'),
    ('cell', 'glycolysis', ''),
    ('room', 'brownian', ''),
    ('walls', 'billiard', ''),
    ('turning', 'tumbling', 'scc.open(scc.runs().length - 1); scc.seek("3"); press("velocities"); press("spins"); press("trails")'),
    ('parallel', 'capsid', 'press("projection")'),
    ('upright', 'gears', 'press("up"); scc.seek("1")'),
    ('drawn', 'drawn_hexokinase', 'scc.open(0); scc.go(0)'),
]

#: How much the pixels of two pictures of one size differ in the mean, of 255, and the part of those that differ by more than 40.
APART = """
  const [one, two, done] = arguments;
  async function pixels(address) {
    const image = new Image(), canvas = document.createElement("canvas"), pen = canvas.getContext("2d");
    image.src = address;
    await image.decode();
    [canvas.width, canvas.height] = [image.naturalWidth, image.naturalHeight];
    pen.drawImage(image, 0, 0);
    return pen.getImageData(0, 0, canvas.width, canvas.height).data;
  }
  (async () => {
    const [a, b] = [await pixels(one), await pixels(two)];
    if (a.length !== b.length) return done([255, 1]);
    const apart = [...a].map((x, i) => Math.abs(x - b[i]));
    done([apart.reduce((sum, x) => sum + x, 0) / a.length, apart.filter((x) => x > 40).length / a.length]);
  })().catch((error) => done(String(error)));"""


def pictured(b, scc):
    """Each scene is that of its picture: edges, letters and shadows may be drawn a little differently by other versions."""
    folder = os.environ.get('PICTURES')
    pages = {}
    for theme in ['light', 'dark']:
        b.prefer(color_scheme=theme)
        for name, model, script in SCENES:
            if model not in pages:
                pages[model] = scc.view(f'specs/models/{model}.sc', '--graph', '50', '--seconds', '20')
            b.open(pages[model])
            b.js('const press = (name) => document.getElementById("tool-" + name).click();' + script)
            # Words may have made panels higher, and the scene is then seen anew.
            b.js('return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 100))))')
            png = saved(b, kind='png', size='own', pixels=200, background='page', legend=False, bar=False, clock=False, axes=False)
            path = os.path.join(folder or PICTURES, f'{name}-{theme}.png')
            if folder:
                with open(path, 'wb') as f:
                    f.write(png)
            with open(path, 'rb') as f:
                kept = f.read()
            blank(b, scc)
            apart = b.driver.execute_async_script(APART, address('image/png', png), address('image/png', kept))
            check(f'the scene {name}, {theme}', isinstance(apart, list) and apart[0] < 2 and apart[1] < 0.01, apart)
    b.prefer(color_scheme='light')


PARTS = [pictured]
