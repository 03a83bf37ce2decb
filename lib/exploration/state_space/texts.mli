(** Components and labels as bytes, which are the same for the same things in each process. *)

open Scc_codec

val bytes : (Buffer.t -> unit) -> string
(** [bytes put] is what [put] adds to an empty buffer. *)

val reading : string -> (Packed.source -> 'a) -> 'a
(** [reading text read] is what [read] finds in the text. It raises [Failure], with what is wrong, if that is not all
    of the text or none of what [read] reads. *)

val label : State_codec.t -> Catalogue.label -> string
(** [label codec l] is a label as bytes. *)

val of_label : State_codec.t -> string -> Catalogue.label
(** [of_label codec text] is the label of these bytes. It raises [Failure] like {!reading}. *)

val make : State_codec.t Lazy.t -> Catalogue.texts
(** [make codec] is the things of a catalogue as bytes. The codec is made when the first one is needed. *)
