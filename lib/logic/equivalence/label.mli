(** What the texts of labels mean to a comparison. *)

open Scc_exact

(** A passing of time: [time(3/2)], or [time(forever)] where nothing happens any more. *)
type passing = For of Rat.t  (** positive *) | Forever

val passing : string -> passing option
(** [None] for every other label. *)

val of_passing : passing -> string

val chance : string -> (string * Rat.t) option
(** Of a label that ends in [chance(c)], as draws and lots do: the text before it, and c. *)

val with_chance : string -> Rat.t -> string

val is_of : string -> string -> bool
(** Whether a label is of a kind: [is_of "weak" s]. *)

val canonical : string -> string
(** The two ends of [bind(a, p.right, q.left)], [weak(...)], [release(...)] and their like, and of [<a, {...}>],
    the bodies of [bounce(p, q)], the bonds of [strong({...})] and [weak({...})], and what is in [{...}]
    ({!Draws}), in the order of their texts: two models may declare their bodies in different orders. Other labels
    stay. *)

(** {1 Patterns} *)

type pattern
(** A text in which each [*] stands for any text, also for none. *)

val pattern : string -> pattern

val matches : pattern -> string -> string list option
(** The whole label: what each [*] stands for, the first ones as short as possible. *)

(** {1 Renaming} *)

type rule

val rule : string -> string -> rule
(** [rule from into]. With [*] or a bracket [(] in [from], a pattern of whole labels: what its stars stand for
    takes the places of the stars of [into], in order (no more stars in [into] than in [from]). Else a name of
    a body, a part, a channel or of something indexed: everywhere in a label where it stands as a whole name or
    as the beginning of one ([p] in [p.right] and [p[1]], not in [pq] or [q.p]). *)

val stars : string -> int
(** How many stars the text has. *)

val rename : rule list -> string -> string
(** The first pattern that matches decides; without one, all names are replaced at once, the longest first. The
    result is {!canonical}. *)
