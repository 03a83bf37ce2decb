(** What the meaning of a model depends on besides its text: the version of the semantics, and the parameters of
    its rules. The head of every report, trace and graph states it. *)

val version : string
(** The version of the semantics, which the rule book names as well. It rises with each change of what a model does
    or of what a property means. *)

val listed : Model.t -> State.t -> (string * string) list
(** [listed m s] is the names and values of the parameters that can matter to [m], which starts from [s] as
    declared:
    - [split step], if a weak split is written somewhere;
    - [timestep], if there are movement steps or bodies turn;
    - [collisions], [binding] and [bonds], if they are not the default (readings I-32, I-33 and I-37);
    - [dynamics], [resolution] and what is rounded, if bodies turn;
    - the rounding of velocities, if there is one. *)

val at_any_time : string * string
(** The entry of {!listed} for models whose bonds may be released at any time. *)

val may_push : Model.t -> State.t -> bool
(** [may_push m s] is true if a split with a push is written in a definition of [m] or a behaviour of [s]
    (reading I-36). *)

val has_lots : Model.t -> State.t -> bool
(** [has_lots m s] is true if a weak split with a chance or a rate is written in a definition of [m] or a behaviour
    of [s] (rule Lot). *)

val line : (string * string) list -> string
(** The parameters of {!listed} as one line, with the version:
    ["semantics 3: split step 1, timestep 1/10"], or ["semantics 3"]. *)

val may_split : Model.t -> State.t -> bool
(** [may_split m s] is true if a weak split is written in a definition of [m] or a behaviour of [s]. *)
