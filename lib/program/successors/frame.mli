(** Frames of numbers of 32 bits and bytes: what comes in and goes out in batches ([specs/successors.md]). *)

open Scc_exchange

exception Lost of string
(** What comes in does not fit its format. *)

val lost : ('a, unit, string, 'b) format4 -> 'a

val number : string -> int -> int
(** At a place. *)

val numbers : string -> int array
(** Of a request: those that follow its kind and how many they are. *)

val bytes_from : int array -> int
(** Where its bytes begin. *)

val put_number : Buffer.t -> int -> unit
val put_numbers : Buffer.t -> int array -> unit

val put : Buffer.t -> int list -> Buffer.t list -> string -> unit
(** A frame: numbers, columns and a text. *)

(** {1 Notes} *)

val note : int -> (string * Json.t) list -> Json.t list -> Json.t list
(** Of what has this index, if there is anything to be told. *)

val text : (string * Json.t) list -> Json.t list -> string
(** With the notes, which come the last first; empty if there is nothing. *)
