type 'a t = { mutable value : 'a option; make : unit -> 'a }

let make make = { value = None; make }

let force t =
  match t.value with
  | Some v -> v
  | None ->
    let v = t.make () in
    t.value <- Some v;
    v
let is_known t = Option.is_some t.value
