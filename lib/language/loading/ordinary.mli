(** Preconditions of commands that explore single states: parameters without ranges, and weak splits on a
    grid. *)

open Scc_base

val on_grid : Loaded.t -> (unit, Diag.t list) result
(** SC0902 for a model whose bonds may be released at any time ({!Scc_calculus.Model.Any_time}), if any
    behaviour has a weak split. *)

val at_point : ?otherwise:string -> Loaded.t -> (unit, Diag.t list) result
(** SC0903 for a model with parameters that have ranges. The hint ends with [otherwise], an alternative for the
    user. *)

val has_ranges : Loaded.t -> (unit, Diag.t list) result
(** SC0208 for a model without parameters that have ranges; for commands that compute where checks hold. *)

val refuse : Loaded.t -> (Loaded.t, Diag.t list) result
(** The model, if it passes {!at_point} and {!on_grid}; else the error of the first that fails. *)
