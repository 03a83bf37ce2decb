(** Frames of 32-bit numbers and bytes: the input and output of batches ([specs/successors.md]). *)

exception Lost of string
(** The input does not fit its format. *)

val lost : ('a, unit, string, 'b) format4 -> 'a
(** Raises {!Lost} with a message. *)

val number : string -> int -> int
(** [number frame at] is the unsigned 32-bit number at the offset [at], little-endian. Raises {!Lost} beyond the
    end. *)

val numbers : string -> int array
(** The numbers of a request, after its kind and their count. Raises {!Lost} if the frame is too short. *)

val bytes_from : int array -> int
(** The offset of the bytes of a request, which follow its numbers. *)

val put_number : Buffer.t -> int -> unit
(** Appends a 32-bit number, little-endian. *)

val put_numbers : Buffer.t -> int array -> unit
(** Appends 32-bit numbers, little-endian. *)

val put : Buffer.t -> int list -> Buffer.t list -> string -> unit
(** [put out numbers columns text] appends a frame with its length: the numbers, the columns and the text. *)
