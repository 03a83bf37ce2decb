(** Writes a module with a digest of what scc is built from; see its dune file. *)
