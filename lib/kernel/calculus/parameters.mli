(** What the meaning of a model depends on besides its text: the version of the semantics, and the parameters of
    its rules. Every report, trace and graph says it in its head. *)

val version : string
(** Of the semantics: of the rule book, which names it. A change of what any model does or of what any property
    means raises it. *)

val listed : Model.t -> State.t -> (string * string) list
(** Names and values of the parameters that can matter to the model, which begins in this state as it is
    declared: the [split step] where a weak split is written somewhere; the [timestep] where there are movement
    steps or turns; [collisions] and [binding] where they are not the default (readings I-32 and I-33); [dynamics],
    [resolution] and what is rounded where bodies turn. *)

val at_any_time : string * string
(** What {!listed} says where bonds may be released at any time. *)

val may_push : Model.t -> State.t -> bool
(** A split with a push is written somewhere (reading I-36). *)

val has_lots : Model.t -> State.t -> bool
(** A weak split with a chance is written somewhere (rule Lot). *)

val line : (string * string) list -> string
(** ["semantics 3: split step 1, timestep 1/10"], or ["semantics 3"]. *)

val may_split : Model.t -> State.t -> bool
(** Whether a weak split is written anywhere, in definitions or in a behaviour of the state. *)
