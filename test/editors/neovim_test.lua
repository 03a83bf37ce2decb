-- Models in Neovim: type, colours by the tree, folds, and the language server, by editors/neovim/scc.lua.
--
--   nvim --headless --clean --cmd 'let g:setting = {…}' -S neovim_test.lua
--
-- g:setting has root, the repository; runtime, a folder with parser/scc.so and queries/scc; work, an empty folder; scc, the
-- program; lsp, whether it has `scc lsp`; answer, where the last line, 'N passed, N failed', is written, after what failed.

local setting = vim.g.setting
local lines, passed, failed = {}, 0, 0

local function expect(what, holds, shown)
  if holds then
    passed = passed + 1
  else
    failed = failed + 1
    table.insert(lines, what .. ': ' .. vim.inspect(shown))
  end
end

local function finish()
  table.insert(lines, passed .. ' passed, ' .. failed .. ' failed')
  vim.fn.writefile(lines, setting.answer)
  vim.cmd('qall!')
end

vim.opt.runtimepath:prepend(setting.runtime)
vim.opt.runtimepath:prepend(setting.root .. '/editors/vim')
vim.opt.swapfile = false
vim.g.scc_program = setting.lsp == 1 and setting.scc or '/nowhere/scc'
-- It was loaded without these folders.
vim.cmd('filetype off | filetype plugin on | syntax on')
vim.cmd('source ' .. vim.fn.fnameescape(setting.root .. '/editors/neovim/scc.lua'))

local function write(name, text)
  local path = setting.work .. '/' .. name
  vim.fn.writefile(vim.split(text, '\n'), path)
  return path
end

local function trees()
  for _, path in ipairs(vim.fn.glob(setting.root .. '/specs/models/*.sc', true, true)) do
    vim.cmd('edit ' .. vim.fn.fnameescape(path))
    expect('the type of ' .. path, vim.bo.filetype == 'scc', vim.bo.filetype)
    local tree = vim.treesitter.get_parser(0, 'scc'):parse()[1]
    expect('the tree of ' .. path, tree:root():type() == 'source_file' and not tree:root():has_error(), tree:root():sexpr())
    vim.cmd('bwipeout!')
  end
end

-- The colour of each name, by the pattern that counts: the last one.
local function colours()
  vim.cmd('edit ' .. vim.fn.fnameescape(setting.root .. '/specs/models/dimer.sc'))
  local buffer = vim.api.nvim_get_current_buf()
  local get = vim.treesitter.query and vim.treesitter.query.get or vim.treesitter.get_query
  local query = (get or require('vim.treesitter.query').get_query)('scc', 'highlights')
  local text_of = vim.treesitter.get_node_text or require('vim.treesitter.query').get_node_text
  local found = {}
  for id, node in query:iter_captures(vim.treesitter.get_parser(buffer, 'scc'):parse()[1]:root(), buffer, 0, -1) do
    found[text_of(node, buffer)] = query.captures[id]
  end
  expect('a word', found['process'] == 'keyword', found['process'])
  expect('a shape', found['Cube'] == 'type', found['Cube'])
  expect('a word of time', found['eventually'] == 'keyword.operator', found['eventually'])
  expect('the tree colours', vim.treesitter.highlighter.active[buffer] ~= nil, vim.treesitter.highlighter.active)
  vim.cmd('bwipeout!')
end

local function server()
  local path = write('wrong.sc', 'process p = box(1, 1, 1) mas 1 [nil]\nprocess q = box(1, 1, 1) mass 1 at translate (9, 0, 0) [nil]\n')
  vim.cmd('edit ' .. vim.fn.fnameescape(path))
  local seen = vim.wait(600000, function()
    return #vim.diagnostic.get(0) > 0
  end, 50)
  local found = vim.diagnostic.get(0)
  expect('an error is shown', seen and found[1].lnum == 0, found)
  vim.api.nvim_buf_set_lines(0, 0, 1, false, { 'process p = box(1, 1, 1) mass 1 [nil]' })
  expect('and goes when it is mended', vim.wait(600000, function()
    for _, one in ipairs(vim.diagnostic.get(0)) do
      if one.severity == vim.diagnostic.severity.ERROR then
        return false
      end
    end
    return true
  end, 50), vim.diagnostic.get(0))
  local at = { textDocument = vim.lsp.util.make_text_document_params(), position = { line = 1, character = 8 } }
  local hover = vim.lsp.buf_request_sync(0, 'textDocument/hover', at, 600000)
  local told = vim.inspect(hover)
  expect('what a name is', told:find('q', 1, true) ~= nil and told:find('contents', 1, true) ~= nil, hover)
end

local good, message = pcall(function()
  trees()
  colours()
  if setting.lsp == 1 then
    server()
  end
end)
expect('no error', good, message)
finish()
