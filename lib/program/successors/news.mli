(** Of what follows states, what has not been told before: requests 4, 5 and 6 of batches
    ([specs/successors.md]). *)

type t

val make : unit -> t
(** Nothing has been told. *)

val expand : t -> Filter.t -> string -> Buffer.t -> unit
(** 4: the states of a frame, and of where their transitions lead, what is not remembered. All is remembered.
    Raises {!Frame.Lost}, as the others do. *)

val meet : t -> string -> Buffer.t -> unit
(** 5: which fingerprints are remembered from before the mark. All are remembered. *)

val keep : t -> string -> Buffer.t -> unit
(** 6: sets the mark, or forgets. *)
