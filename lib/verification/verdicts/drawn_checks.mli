(** What a drawing of regions of starts shows: for which values of the parameters checks hold, and probabilities
    as functions of the parameters. *)

open Scc_verify
open Scc_regions

val named : Verdict.outcome list -> Check.report -> (string * Where.t) list
(** [named outcomes report] has the checks of [outcomes] by their names, with the values for which each holds. It
    is empty where a limit has ended all work. *)

val split :
  ?name:(string -> string -> string) ->
  Verdict.outcome list ->
  (string * Where.t) list -> (string * Where.t) list * (string * Chances.t) list
(** [split ?name outcomes named] has the claims among [named], and the probabilities and means among [outcomes]. A
    number whose least and greatest value over the choices differ is there twice, with the side in its name:
    [name check side], by default [check (side)]. *)
