type 'a t = { most : int; mutable entries : 'a list  (** the last one first *) }

let create ~most = { most; entries = [] }
let find t is = List.find_opt is t.entries
let keep t entry = t.entries <- entry :: List.filteri (fun i _ -> i < t.most - 1) t.entries
let retain t is = t.entries <- List.filter is t.entries
