let map f list = List.rev (List.rev_map f list)

let mapi f list =
  let add (i, mapped) x = (i + 1, f i x :: mapped) in
  List.rev (snd (List.fold_left add (0, []) list))

let append a b = List.rev_append (List.rev a) b
let concat lists = List.rev (List.fold_left (fun all list -> List.rev_append list all) [] lists)
