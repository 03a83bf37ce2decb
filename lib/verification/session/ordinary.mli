(** What looks at one state after the other needs a model of one point, and weak splits on a grid. *)

open Scc_base

val on_grid : Loaded.t -> (unit, Diag.t list) result
(** SC0902 for a model whose bonds may be released at any time ({!Scc_calculus.Model.Any_time}), if a weak split is
    written anywhere in it. *)

val at_point : ?otherwise:string -> Loaded.t -> (unit, Diag.t list) result
(** SC0903 for a model with parameters of which ranges are known. Its hint ends with [otherwise], what else can be
    done. *)

val has_ranges : Loaded.t -> (unit, Diag.t list) result
(** For who asks where checks hold: SC0208 for a model without parameters of which ranges are known. *)

val refuse : Loaded.t -> (Loaded.t, Diag.t list) result
(** The model, if it passes both. *)
