(** Names of faces, from what a file calls them: its groups, objects or nodes. *)

val names : vertices:string array -> string option array -> string array
(** [names ~vertices labels], for the label of each face in order: the label of one face alone is its name; of
    several faces that have a label in common the first is its name with 0 after it, the next with 1, and so on
    ([_0] after a digit); all others, and all faces of a file where every face has the same label, are [f0], [f1],
    … by their places in the file. What is neither a letter nor a digit becomes [_], and [g] comes before what does
    not begin with a letter. Names are distinct, also from those of the vertices: a face whose name is taken counts
    as one without a label. *)
