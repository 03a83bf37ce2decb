(** The option [--parametric] of [scc check]: a parameter of which probabilities are functions (rule Parametric).
*)

open Scc_base
open Scc_state_space
open Scc_loading

val unfit : Check_extras.t -> string option
(** [unfit extras] is the first option that does not go with [--parametric], if that is given; [None] if all do. *)

val reductions : Reduction.kind list -> Reduction.kind list
(** [reductions kinds] is those of the kinds that keep each draw apart. *)

val fitting : Loaded.t -> (unit, Diag.t list) result
(** SC0901 if other parameters of the model have ranges, or instants are left open. *)

val at_value : Loaded.t -> Diag.t list -> Diag.t list
(** [at_value l diagnostics] is the diagnostics of an exploration of [l], with the value of the parameter at which
    they came up. *)

val explored :
  load:(attempt:int -> (Loaded.t, Diag.t list) result) -> Loaded.t ->
  (Loaded.t -> ('a, Diag.t list) result) ->
  (Loaded.t * 'a, Diag.t list) result
(** [explored ~load l explore] is the result of [explore l], with [l]. If functions that differ have one value at
    the value of the parameter that was explored, [load] gives the model with another value, which is explored. A
    probability that vanishes for some value is an error. *)
