[
  (shape_declaration)
  (compound_declaration)
  (behaviour_declaration)
  (process_declaration)
  (fixed_declaration)
  (for_declaration)
  (motion_declaration)
  (network_declaration)
  (block_comment)
] @fold
