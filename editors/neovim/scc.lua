-- Models of scc in Neovim (0.7 or newer): put this file into ~/.config/nvim/plugin, and the folder editors/vim of scc into
-- the runtime path (or copy its folders to ~/.config/nvim).
--
-- `scc` has to be in PATH. It is the language server. With the parser of editors/tree-sitter-scc (see its README) in a folder
-- `parser` of the runtime path, and its queries in `queries/scc`, colours come from the tree.

local function root(file)
  local found = vim.fs and vim.fs.find('.git', { path = file, upward = true })[1]
  return found and vim.fs.dirname(found) or vim.fn.fnamemodify(file, ':p:h')
end

local function open(buffer)
  -- Not every installation has the parser: the file of syntax colours then.
  if #vim.api.nvim_get_runtime_file('parser/scc.so', false) > 0 then
    if vim.treesitter.start then
      vim.treesitter.start(buffer, 'scc')
    else
      vim.treesitter.highlighter.new(vim.treesitter.get_parser(buffer, 'scc'))
    end
  end
  local program = vim.g.scc_program or 'scc'
  if vim.fn.executable(program) == 0 then
    return
  end
  local config = { name = 'scc', cmd = { program, 'lsp' }, root_dir = root(vim.api.nvim_buf_get_name(buffer)) }
  if vim.lsp.start then
    vim.lsp.start(config, { bufnr = buffer })
  else
    _G.scc_client = _G.scc_client or vim.lsp.start_client(config)
    if _G.scc_client then
      vim.lsp.buf_attach_client(buffer, _G.scc_client)
    end
  end
end

vim.api.nvim_create_autocmd('FileType', {
  pattern = 'scc',
  callback = function(event)
    open(event.buf)
  end,
})
