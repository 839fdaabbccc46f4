# Writes posterior_reference.csv: draws with the R-hat and bulk ESS that the R package posterior (1.4.0,
# r-cran-posterior) computes for them.  One case per line; the draws chain by chain, six digits each.
#   Rscript make_posterior_reference.R > posterior_reference.csv
suppressMessages(library(posterior))
set.seed(20210601)

ar <- function(n, chains, rho, shift = rep(0, chains), scale = rep(1, chains)) {
  sapply(seq_len(chains), function(c)
    shift[c] + scale[c] * as.numeric(arima.sim(list(ar = rho), n, n.start = 100)))
}
iid <- function(n, chains, draw = rnorm) matrix(draw(n * chains), n, chains)

cases <- list(
  independent          = iid(100, 4),
  slow                 = ar(150, 4, 0.9),
  very_slow            = ar(100, 4, 0.99),
  one_chain_shifted    = ar(100, 4, 0.3, shift = c(0, 0, 0, 1.5)),
  one_chain_wider      = ar(100, 4, 0.3, scale = c(1, 1, 1, 6)),
  antithetic           = ar(100, 4, -0.8),
  many_short_chains    = ar(62, 16, 0.5),
  one_chain            = ar(100, 1, 0.6),
  odd_length           = ar(51, 3, 0.4),
  heavy_tails          = iid(60, 4, rcauchy),
  rounded_to_ties      = round(ar(60, 4, 0.5)),
  clamped_to_a_ceiling = pmin(ar(60, 4, 0.5), 0.2),
  one_constant_chain   = cbind(rep(0.25, 40), iid(40, 3)),
  trend                = ar(60, 3, 0.2) + 0.05 * seq_len(60),
  length_6             = iid(6, 2),
  length_10            = iid(10, 2),
  length_11            = iid(11, 3),
  length_12            = iid(12, 4),
  length_13            = iid(13, 2),
  length_16            = ar(16, 2, -0.5))

cat("case,rhat,ess_bulk,chains,draws\n")
for (name in names(cases)) {
  text <- sprintf("%.6g", cases[[name]])
  x <- matrix(as.numeric(text), ncol = ncol(cases[[name]]))
  cat(sprintf("%s,%.15g,%.15g,%d,%s\n", name, rhat(x), suppressWarnings(ess_bulk(x)), ncol(x),
              paste(text, collapse = " ")))
}
