(** How many things there are, in words. *)

val count : int -> string -> string -> string
(** [count n one many] is the number [n] before the word for so many: [count 1 "face" "faces"] is ["1 face"]. *)
