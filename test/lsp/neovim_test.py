"""`scc lsp` in Neovim without a window, as Debian has it: neovim_test.py SCC FOLDER. The last line is 'N passed, N failed'.

Neovim starts the server by its own client, opens a model with an error, waits for the diagnostic, and asks for hover,
definition and a new name; the script in Lua writes what it got as JSON.
"""

import json
import os
import subprocess
import sys

SCRIPT = """
local out = {}
vim.cmd('edit model.sc')
local id = vim.lsp.start_client({ name = 'scc', cmd = { '%s', 'lsp' }, root_dir = vim.fn.getcwd() })
vim.lsp.buf_attach_client(0, id)
local function wait(f) return vim.wait(30000, f, 20) end
out.attached = wait(function() return #vim.lsp.buf_get_clients(0) > 0 end)
out.diagnosed = wait(function() return #vim.diagnostic.get(0) > 0 end)
local found = {}
for _, d in ipairs(vim.diagnostic.get(0)) do table.insert(found, { d.lnum, d.col, d.end_col, d.code or d.user_data.lsp.code }) end
out.found = found
local function ask(method, line, character, more)
  local params = { textDocument = vim.lsp.util.make_text_document_params(), position = { line = line, character = character } }
  for k, v in pairs(more or {}) do params[k] = v end
  local answers = vim.lsp.buf_request_sync(0, method, params, 30000)
  for _, a in pairs(answers or {}) do return a.result end
end
out.hover = ask('textDocument/hover', 2, 8)
out.definition = ask('textDocument/definition', 2, 12)
-- Neovim applies the edits itself.
local edit = ask('textDocument/rename', 0, 6, { newName = 'Brick' })
vim.lsp.util.apply_workspace_edit(edit, 'utf-16')
out.lines = vim.api.nvim_buf_get_lines(0, 0, -1, false)
vim.api.nvim_buf_set_text(0, 2, 31, 2, 35, { 'left' })
out.mended = wait(function() return #vim.diagnostic.get(0) == 0 end)
vim.lsp.stop_client(id)
out.stopped = wait(function() return vim.lsp.client_is_stopped(id) end)
vim.fn.writefile({ vim.fn.json_encode(out) }, 'out.json')
vim.cmd('qa!')
"""
MODEL = "shape Cube = box(1, 1, 1)\n// é\nprocess p = Cube mass 1 [<a, {lefd}>. nil]\n"

passed = failed = 0


def same(what, found, wanted):
    global passed, failed
    if found == wanted:
        passed += 1
    else:
        failed += 1
        print(f"FAILED: {what}: {found!r}, and not {wanted!r}")


def main(scc, folder):
    os.makedirs(folder, exist_ok=True)
    for name, text in [("model.sc", MODEL), ("script.lua", SCRIPT % scc)]:
        with open(os.path.join(folder, name), "w") as file:
            file.write(text)
    home = {**os.environ, "HOME": folder, "XDG_CONFIG_HOME": folder, "XDG_DATA_HOME": folder, "XDG_STATE_HOME": folder}
    subprocess.run(["nvim", "--headless", "-u", "NONE", "-n", "-S", "script.lua"], cwd=folder, env=home, timeout=120, check=True, capture_output=True)
    with open(os.path.join(folder, "out.json")) as file:
        out = json.load(file)
    for what in ["attached", "diagnosed", "mended", "stopped"]:
        same(what, out[what], True)
    same("the diagnostic", out["found"], [[2, 30, 34, "SC0203"]])
    same("hover", "process `p`" in out.get("hover", {"contents": {"value": ""}})["contents"]["value"].replace("\\", ""), True)
    same("definition", [d["range"]["start"] for d in out["definition"]], [{"line": 0, "character": 6}])
    same("a new name", out["lines"][0::2], ["shape Brick = box(1, 1, 1)", "process p = Brick mass 1 [<a, {lefd}>. nil]"])
    print(f"{passed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(os.path.abspath(sys.argv[1]), sys.argv[2]))
