The server ends with 1 if it was not told to shut down, as the protocol wants:

  $ scc lsp < /dev/null
  [1]
  $ message() { printf 'Content-Length: %d\r\n\r\n%s' "${#1}" "$1"; }
  $ message '{"jsonrpc":"2.0","method":"exit"}' | scc lsp
  [1]

and with 0 if it was. What it says is in the same frames:

  $ { message '{"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":{}}}'
  >   message '{"jsonrpc":"2.0","id":"two","method":"textDocument/hover","params":{}}'
  >   message '{"jsonrpc":"2.0","id":3,"method":"shutdown"}'
  >   message '{"jsonrpc":"2.0","method":"exit"}'; } | scc lsp --stdio > out
  $ tr -d '\r' < out | sed 's/}Content-Length: [0-9]*$/}/; s/^{"jsonrpc":"2.0","id":1,"result":{.*"positionEncoding":"utf-16".*/initialized/' | grep -v '^Content-Length\|^$'
  initialized
  {"jsonrpc":"2.0","id":"two","error":{"code":-32602,"message":"the params have no `textDocument`"}}
  {"jsonrpc":"2.0","id":3,"result":null}

It has no arguments:

  $ scc lsp model.sc 2> err
  [64]
  $ head -1 err
  scc: too many arguments, don't know what to do with 'model.sc'
