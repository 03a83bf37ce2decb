(* So many passes are made in any case; after them only while each changes one number of so many. *)
let few = 64
let share = 16

let run ~size look =
  let rec go n =
    let changed = ref 0 in
    for i = 0 to size - 1 do
      if look (if n land 1 = 0 then i else size - 1 - i) then incr changed
    done;
    !changed = 0 || ((n < few || !changed > size / share) && go (n + 1))
  in
  go 0
