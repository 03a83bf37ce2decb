(** Names of faces, from the labels in a file: its groups, objects or nodes. *)

val names : vertices:string array -> string option array -> string array
(** [names ~vertices labels] are the names of the faces, for the label of each face in order. A label of one
    face is its name. If several faces share a label, the first gets the label followed by 0, the next by 1,
    and so on ([_0] after a digit). All other faces are [f0], [f1], … by their places in the file, and so are
    all faces if every face has one label. Characters other than letters and digits become [_]. [g]
    precedes a label that does not begin with a letter, and the label of one face that is a word of the language
    ({!Scc_base.Language_words.is_reserved}). Names are distinct, also from those of the vertices. A
    face whose name is taken counts as unlabelled. *)
