open Cmdliner

let text =
  [
    `S Manpage.s_description;
    `P
      "Explores two models and decides whether they are equivalent: whether an observer of their transitions, \
       but not of their states, cannot distinguish them. If they differ, the report has a shortest trace of one \
       that the other lacks, if there is one, and a formula that is true of the first and false of the second. \
       Both are checked on the two graphs before they are printed.";
    `P
      "Labels are those of $(b,scc trace), such as $(b,bind(a, p.right, q.left\\)), with the two ends (and the \
       bonds of a reaction) in the order of their texts. Where a model is at rest time passes for ever: \
       $(b,time(forever\\)).";
    `P
      "All draws of one instant are one transition, since the order of draws has no meaning: $(b,{keep(b, r.top, \
       s.top\\), release(a, p.right, q.left\\)} chance(1/6\\)), with the draws in the order of their texts, and \
       the product of the chances. $(b,--rename) and $(b,--hide) apply to single draws; hidden draws are left \
       out. The order in which free ends choose how they let go is not visible either ($(b,choose(...\\))). \
       Draws that have not been explored to the end of their instant are unknown.";
    `P
      "Only labels are compared, and they have neither places nor motions. So equivalent models are equivalent \
       by themselves, and not in every network: beside a third body, which one of them may hit and the other \
       not, they may differ. No relation here is a congruence for parallel composition of networks. None of them \
       preserves properties about places, distances, velocities and behaviours. They preserve properties about \
       events, as far as the relation distinguishes time and silent transitions.";
    `S "RELATIONS";
    `I
      ( "$(b,trace)",
        "the same sequences of labels. Silent transitions and the passing of time are invisible." );
    `I
      ( "$(b,weak)",
        "weak bisimilarity: each transition of one is answered by the other with the same label, with silent \
         ones before and after it, and so on from there. The passing of time is silent." );
    `I
      ( "$(b,branching)",
        "branching bisimilarity: as weak, and the silent transitions of an answer do not change the \
         possibilities. This is the default. Neither relation considers divergence: infinite silence is no \
         difference." );
    `I
      ( "$(b,strong)",
        "bisimilarity, transition by transition. A passing of time is a transition $(b,time), whatever its \
         duration; consecutive passings, with nothing else possible in between, are one." );
    `I
      ( "$(b,timed)",
        "as strong, and durations count. Time is additive, $(b,time(1\\)) and then $(b,time(2\\)) is \
         $(b,time(3\\)), and a longer passing is split wherever the other model has an instant." );
    `P
      "Each of strong, branching, weak and trace implies the next one; between models, timed implies strong.";
    `S "FORMULAS";
    `I ("$(b,<a>f)", "some transition a leads to a state where f is true; $(b,[a]f): every transition a does.");
    `I
      ( "$(b,<<a>>f), $(b,[[a]]f)",
        "the same with silent transitions before and after a. With $(b,tau): by silent transitions, or by none." );
    `I ("$(b,(f until <a>g\\))", "silent transitions while f is true, then a, and then g is true.");
    `I ("$(b,(f until g\\))", "silent transitions, or none, while f is true, to a state where g is true.");
    `I ("$(b,<time(d\\)>f)", "after exactly d, over any instants on the way, f can be true.");
    `S "GRAPHS";
    `P
      "A file whose name ends in $(b,.aut) is a graph, as $(b,scc explore), CADP, mCRL2 and others write it. \
       $(b,tau) and $(b,i) are silent, and $(b,time(1/2\\)) and $(b,time(forever\\)) pass time. A transition \
       $(b,unexplored) says that some transitions of its state are unknown.";
    `S "BOUNDS";
    `P
      "Bounds are for each of the two models; those of seconds and of memory include the comparison. If a model \
       was not explored completely, the two are never called equivalent. They are called different only if the \
       explored part proves it.";
  ]
  @ Options.diagnostics_man
  @ [
    `S Manpage.s_examples;
    `Pre "  scc compare a.sc b.sc --modulo weak --rename left=p --hide bounce";
    `Pre "  scc compare chain.sc chain.sc --left n=3 --right n=4 --modulo trace";
    `Pre "  scc compare model.aut specification.aut --modulo branching --json";
  ]
