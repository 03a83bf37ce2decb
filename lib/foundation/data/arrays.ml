let equal equal a b = Array.length a = Array.length b && Array.for_all2 equal a b

let compare compare a b =
  let rec from i =
    if i = Array.length a then 0
    else
      let c = compare a.(i) b.(i) in
      if c <> 0 then c else from (i + 1)
  in
  Int.compare (Array.length a) (Array.length b) <?> fun () -> from 0
