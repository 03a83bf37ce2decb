type kind = Blank | Line | Block
type t = { kind : kind; text : string; start : int; stop : int; own_line : bool }

let is_comment t = match t.kind with Blank -> false | Line | Block -> true
