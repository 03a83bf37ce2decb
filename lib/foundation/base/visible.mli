(** Texts that come from outside, as they are shown: whatever would change how a terminal shows what is around it
    is written out, as [<U+202E>]. That is characters that change the direction ({!Bidirectional}) and control
    characters, those from U+0080 to U+009F included; a byte that is not of UTF-8 is written as [<0x9B>]. *)

val text : ?kept:string list -> string -> string
(** Line ends and tabs stay, and so do these sequences. *)

val line : string -> string
(** [line text] is {!text} for a text that has to stay in one line: line ends and tabs are written out, too. *)

val at : string -> int -> (int * int) option
(** The code point and the bytes of a character that is written out, where one begins; line ends and tabs are among
    them. *)
