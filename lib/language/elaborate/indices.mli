(** The numbers that variables of loops stand for, inside expressions and laws. *)

open Scc_syntax

val numbers : Report.t -> Env.t -> Ast.name -> Ast.bounds -> Env.value list option
(** Those of a range that its condition admits, in order; [None] where it was reported what is wrong with it. *)

val scopes : Report.t -> Env.t -> Ast.range list -> Env.t list option
(** A scope for each choice of numbers from some ranges, of which later ones may use the variables of earlier
    ones: the last changes first. At most {!Limits.items}; [None] where it was reported what is wrong. *)
