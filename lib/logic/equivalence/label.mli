(** The meaning of labels for comparisons: passings of time, canonical forms, patterns and renaming. *)

open Scc_exact

(** A passing of time: [time(3/2)], or [time(forever)] after which nothing happens. *)
type passing = For of Rat.t  (** positive *) | Forever

val passing : string -> passing option
(** [passing text] is the passing of time that a label stands for; [None] for any other label. *)

val of_passing : passing -> string
(** [of_passing p] is the label [time(d)] or [time(forever)]. *)

val chance : string -> (string * Rat.t) option
(** [chance text] is the text before [chance(c)] and the number c, for a label that ends so, as draws and lots do.
*)

val with_chance : string -> Rat.t -> string
(** [with_chance text c] is the label of a draw with this chance. {!chance} takes it apart. *)

val is_of : string -> string -> bool
(** [is_of kind text] is true if the label is of this kind: [is_of "weak" text]. *)

val canonical : string -> string
(** [canonical text] is the label with some of its parts sorted as texts, since two models may declare their bodies
    in different orders. Sorted are the two ends of [bind(a, p.right, q.left)], and those of [close], [weak],
    [release], [keep], [first], [choose] and [<a, {...}>]. So are the bodies of [bounce(p, q)], the bonds of
    [strong({...})] and [weak({...})], and the draws in [{...}] ({!Draws}). Other labels stay. *)

(** {1 Patterns} *)

type pattern
(** A text in which each [*] stands for any text, also for none. *)

val pattern : string -> pattern
(** [pattern text] is the pattern of [text]; all characters but [*] stand for themselves. *)

val matches : pattern -> string -> string list option
(** [matches p text] is the text that each [*] stands for, if the pattern matches all of [text]. Earlier stars
    stand for texts that are as short as possible. *)

(** {1 Renaming} *)

type rule

val rule : string -> string -> rule
(** [rule from into] renames [from] to [into]. If [from] has a star [*] or an opening bracket, it is a pattern of
    whole labels. The texts of its stars replace the stars of [into] in order; [into] has no more stars than
    [from]. Otherwise [from] is the name of a body, a part, a channel or an indexed thing. It is replaced wherever
    it stands as a whole name or as the beginning of a path: [p] in [p.right] and [p[1]], but not in [pq] or [q.p].
*)

val stars : string -> int
(** [stars text] is the number of stars [*] in the text. *)

val rename : rule list -> string -> string
(** [rename rules label] applies the first pattern that matches. If none matches, all names are replaced
    simultaneously; where several fit, the longest is. The result is {!canonical}. *)
