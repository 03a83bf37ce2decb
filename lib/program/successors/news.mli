(** The new ones among the targets of transitions: requests 4, 5 and 6 of batches ([specs/successors.md]). *)

(** The fingerprints met so far, with a mark. *)
type t

val make : unit -> t
(** No fingerprints. *)

val expand : t -> Filter.t -> string -> Buffer.t -> unit
(** Request 4: expands the states of a frame, and writes those targets of their transitions whose fingerprints
    are new. All fingerprints are stored. Raises {!Frame.Lost}, as the other requests do. *)

val meet : t -> string -> Buffer.t -> unit
(** Request 5: writes which fingerprints were stored before the mark. All of them are stored. *)

val keep : t -> string -> Buffer.t -> unit
(** Request 6: sets the mark, or removes fingerprints. *)
