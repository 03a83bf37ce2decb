(** The terms of a model by number. All behaviours of reachable states consist of these terms and of the times that
    delays still last. Equal models give equal numbers. *)

open Scc_calculus

type t

val make : Model.t -> State.t -> t
(** [make m initial] numbers the terms of the definitions of [m] and of the behaviours in [initial], with all their
    subterms. It numbers the names of the channels in them and of the bonds of [initial] as well. *)

val put : t -> Buffer.t -> Behaviour.t -> unit
(** Appends the bytes of a behaviour. A behaviour that does not consist of the numbered terms is a bug. *)

val read : t -> Packed.source -> Behaviour.t
(** Reads a behaviour. Raises {!Packed.Malformed} for bytes that mean none, and for terms nested deeper than
    1000. *)

val put_name : t -> Buffer.t -> string -> unit
(** Appends the number of the name of a channel. A name that is not numbered is a bug. *)

val read_name : t -> Packed.source -> string
(** Reads the name of a channel. Raises {!Packed.Malformed} for a number without a name. *)
