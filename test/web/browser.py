"""A headless Chromium, and the pages of scc view in it."""
import json
import os
import shutil
import subprocess
import time

try:
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
    from selenium.webdriver.support.ui import Select
except ImportError:  # told by `missing`
    webdriver = None


def program(*names):
    return next((path for name in names if (path := shutil.which(name))), None)


def missing():
    """What these tests need and is not here, or None."""
    if webdriver is None:
        return 'python3-selenium is not installed'
    if not program('chromium', 'chromium-browser', 'google-chrome'):
        return 'chromium is not installed'
    if not program('chromedriver'):
        return 'chromium-driver is not installed'
    return None


# Flags of a browser that cannot draw scenes, which would take most of the time.
WITHOUT_SCENES = ['--disable-3d-apis']


#: Seconds after which nothing is awaited any more.
HANG = 600


class Browser:
    def __init__(self, width=1400, height=900, flags=()):
        options = webdriver.ChromeOptions()
        options.binary_location = program('chromium', 'chromium-browser', 'google-chrome')
        drawing = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist']
        for flag in ['--headless=new', '--no-sandbox', '--disable-dev-shm-usage', *(flags or drawing)]:
            options.add_argument(flag)
        options.set_capability('goog:loggingPrefs', {'browser': 'ALL'})
        self.driver = webdriver.Chrome(service=Service(program('chromedriver')), options=options)
        self.driver.set_script_timeout(HANG)
        self.shown = None
        self.size(width, height)

    def size(self, width, height):
        self.command('Emulation.setDeviceMetricsOverride', width=width, height=height, deviceScaleFactor=1,
                     mobile=width < 500)

    def command(self, name, **arguments):
        return self.driver.execute_cdp_cmd(name, arguments)

    def prefer(self, **features):
        """Media features, as color_scheme='dark' or reduced_motion='reduce'."""
        self.command('Emulation.setEmulatedMedia', features=[
            {'name': 'prefers-' + name.replace('_', '-'), 'value': value} for name, value in features.items()])

    def open(self, path, fragment=''):
        if path == self.shown:  # or it would not be loaded anew
            self.driver.get('about:blank')
        self.shown = path
        self.driver.get_log('browser')
        self.driver.get('file://' + os.path.abspath(path) + ('#' + fragment if fragment else ''))
        return self.wait('return document.body && document.body.dataset.ready === "true"')

    def js(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def wait(self, script):
        """What a script gives, once it is something; or at last, when nothing comes: no judgment of how fast it is."""
        end = time.monotonic() + HANG
        while True:
            value = self.js(script)
            if value or time.monotonic() > end:
                return value
            time.sleep(0.02)

    def complaints(self):
        """What the console was told."""
        return [entry['message'] for entry in self.driver.get_log('browser')]

    def find(self, test):
        return self.driver.find_element(By.CSS_SELECTOR, f'[data-testid="{test}"]')

    def pick(self, test, value):
        """Chooses from a list, or writes into a field, as a user does."""
        self.js('''
          const box = document.querySelector(`[data-testid="${arguments[0]}"]`);
          box.value = arguments[1];
          box.dispatchEvent(new Event("change", { bubbles: true }));''', test, value)

    def all(self, selector):
        return self.driver.find_elements(By.CSS_SELECTOR, selector)

    def keys(self, *keys):
        ActionChains(self.driver).send_keys(*keys).perform()

    def state(self):
        return self.js('return scc.state()')

    def text(self, test):
        return self.js('return document.querySelector(`[data-testid="${arguments[0]}"]`).textContent', test)

    def quit(self):
        self.driver.quit()


class Program:
    """The program under test."""

    def __init__(self, path, work):
        self.path = path
        self.work = work
        self.count = 0

    def run(self, *arguments):
        return subprocess.run([self.path, *arguments], capture_output=True, text=True, timeout=HANG)

    def file(self, ending):
        self.count += 1
        return os.path.join(self.work, f'{self.count}{ending}')

    def view(self, model, *arguments):
        """The page of a model."""
        page = self.file('.html')
        ended = self.run('view', model, '-o', page, *arguments)
        if ended.returncode != 0:
            raise RuntimeError(f'scc view {model}: {ended.stderr}')
        return page

    def trace(self, model, data, steps, values=None, *arguments):
        """The states of the run that these steps lead to, by scc trace; without steps, of first choices."""
        parameters = {**data['parameters'], **(values or {})}
        if steps is None:
            defined = [text for name, value in parameters.items() for text in ['-D', f'{name}={value}']]
            return self.states(['trace', model, *defined, *arguments])
        schedule = self.file('.json')
        choices = [{'label': data['labels'][step['label']]['text']} for step in steps]
        for choice, step in zip(choices, steps):
            if step['choice'] is not None:
                choice['choice'] = step['choice']
        document = {'format': 'scc-schedule', 'version': 2, 'parameters': parameters, 'choices': choices}
        with open(schedule, 'w') as f:
            json.dump(document, f)
        return self.states(['trace', model, '--schedule', schedule, *arguments])

    def states(self, command):
        ended = self.run(*command)
        lines = [json.loads(line) for line in ended.stdout.splitlines()]
        if ended.returncode not in (0, 2):
            raise RuntimeError(f'scc {command}: {ended.stderr}')
        return [line for line in lines if 'state' in line]
