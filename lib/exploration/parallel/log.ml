type t = { next : unit -> string option; keep : string -> unit }

let none = { next = (fun () -> None); keep = ignore }
