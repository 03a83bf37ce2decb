(** Texts that come from outside, as they are shown: whatever would change how a terminal shows what is around it
    is written out, as [<U+202E>]. That is characters that change the direction ({!Bidirectional}) and control
    characters, those from U+0080 to U+009F included; a byte that is not of UTF-8 is written as [<0x9B>]. *)

val text : ?kept:string list -> string -> string
(** [text ~kept s] is [s] with such characters and bytes written out. Line feeds and tabs stay, and so do the
    sequences of bytes [kept]; a carriage return is written out. *)

val line : string -> string
(** [line text] is {!text} for a text that has to stay in one line: line ends and tabs are written out, too. *)

val at : string -> int -> (int * int) option
(** [at s i] is the code point and the number of bytes of the character that begins at byte [i], if {!line} writes
    it out. Line ends and tabs are among these characters. [i] is an index of [s]. *)
