(** The numbers of loop variables inside expressions and laws. *)

open Scc_syntax

val numbers : Report.t -> Env.t -> Ast.name -> Ast.bounds -> Env.value list option
(** The integers of a range that satisfy its condition, in order. It is [None] after a fault, which is reported;
    more than {!Limits.items} are SC0111. *)

val scopes : Report.t -> Env.t -> Ast.range list -> Env.t list option
(** A scope for each choice of numbers from some ranges. Later ranges may use the variables of earlier ones, and
    the last changes fastest. It is [None] after a fault, which is reported; more than {!Limits.items} are
    SC0111. *)
