[
  (shape_declaration)
  (compound_declaration)
  (hull)
  (block)
  (choose)
] @indent.begin

["}" "]" ")"] @indent.branch
"}" @indent.end
(block_comment) @indent.ignore
