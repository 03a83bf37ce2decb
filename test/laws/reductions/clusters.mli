(** Random networks of several clusters, near enough to each other that they sometimes meet, and searches that ask
    for the first of them. *)

open Scc_calculus
open Scc_property

type clusters

val assemble : clusters -> Model.t * State.t
(** The model, and the initial state. It keeps absolute time. *)

type question = { clusters : clusters; formula : Property.temporal }

val question : question QCheck2.Gen.t
val print : question -> string
