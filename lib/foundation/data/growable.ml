type 'a t = { mutable data : 'a array; mutable length : int }

let create () = { data = [||]; length = 0 }
let length a = a.length

let get a i =
  if i < 0 || i >= a.length then Scc_base.Bug.fail __POS__ "index out of range" else a.data.(i)

let push a x =
  if a.length = Array.length a.data then begin
    let data = Array.make (Int.max 16 (2 * a.length)) x in
    Array.blit a.data 0 data 0 a.length;
    a.data <- data
  end;
  a.data.(a.length) <- x;
  a.length <- a.length + 1

let set a i x =
  if i < 0 || i >= a.length then Scc_base.Bug.fail __POS__ "index out of range" else a.data.(i) <- x
