(** Places of a text as the protocol has them: lines from 0, and characters in one of three units. *)

(** What a character is: a byte of UTF-8, a unit of UTF-16, or a code point. *)
type encoding = Utf8 | Utf16 | Utf32

val name : encoding -> string
(** The name of an encoding in the protocol. *)

val chosen : string list -> encoding
(** The first encoding of a list that is known; UTF-16 if there is none. *)

(** A text with its lines. A line ends with a line feed, a carriage return, or both. *)
type t

val make : encoding -> string -> t
(** The places of a text. *)

val of_offset : t -> int -> int * int
(** The line and character of an offset in bytes; one past the end is the end. *)

val offset : t -> int * int -> int
(** The offset of a line and character. A character past the end of its line is the end of the line, a line past
    the end of the text is the end of the text, and a place within a code point is its beginning. *)
