(** What a process tells of the edges of a state to the one that numbers the states: a row of numbers in memory
    that they share. {!Explore} puts and reads them. *)

open Bigarray

type words = (int, int_elt, c_layout) Array1.t

val word : words -> int -> int
(** [word words at] is the number at a place. It is not checked that there is one. *)

exception Too_long
(** There is no room for the answer. *)

(** {1 Lists} *)

val first_list : int
(** [first_list] is how far the first list of an answer is from the beginning of the answer. *)

val second_list : words -> int -> int
(** [second_list words at] is the place of the second list of the answer at [at]. *)

val version : words -> int -> int
(** [version words at] is the version of the states by which the edges of the answer at [at] were looked at. *)

val left_out : words -> int -> int
(** [left_out words at] is the number of edges that the answer at [at] leaves out, as they change nothing. *)

val count : int -> int
(** [count heading] is the number of steps in a list with this heading. *)

val flag_bits : int
(** The number of flags in a heading, below the number of steps. *)

val labels_known : int
(** The flag of a heading: all labels of the list had come up before. *)

val all_timed : int
(** The flag of a heading: all steps take time. *)

(** {1 Steps} *)

val after : words -> int -> int
(** [after words at] is the place after the step at [at]. *)

val label : int -> int
(** [label step] is the label of a step. *)

val label_shift : int
(** The bits of a step below its label. *)

val most_label : int
(** Labels are less than this. *)

val target : int -> int
(** [target step] is the target of a step to a known state. *)

val has : int -> int -> bool
(** [has flag number] is true if the flag is set in a step or a heading. *)

val is_new : int
(** The flag of a step to a state that was not known. The key of its tuple follows. *)

val is_dull : int
(** The flag of a step to a known state for which it changes nothing; or to a new one of which a visitor is not
    told. *)

val has_entered : int
(** The flag of a step to a new state all components of which had come up before. *)
